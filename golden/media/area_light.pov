// Area lights in the air, with and without area_illumination, and a light with media_attenuation.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 1, 0> angle 45 }
media { scattering { 3, 0.05 } absorption 0.02 intervals 3 samples 6 }
plane { y, 0 pigment { rgb 0.7 } }
plane { -z, -3 pigment { rgb <0.6, 0.5, 0.4> } }
box { <-0.9, 1.4, -0.4>, <-0.1, 1.5, 0.4> pigment { rgb <0.8, 0.2, 0.1> } }
light_source { <-0.8, 3.6, 0> rgb 0.8 area_light 0.6*x, 0.6*z, 3, 3 adaptive 1 fade_distance 2 fade_power 2 }
light_source { <1.8, 3, -0.5> rgb <0.3, 0.2, 0.1> area_light 0.5*x, 0.5*z, 2, 2 area_illumination fade_distance 2 fade_power 2 }
light_source { <0, 3, -1> rgb <0.1, 0.3, 0.2> media_attenuation on }
