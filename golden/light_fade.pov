// light: fade_distance and fade_power, a shadowless light, and two lights whose shadows cross.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4, -6> look_at 0 angle 42 }
light_source { <-2, 2, 0> rgb <1.5, 1.2, 0.8> fade_distance 1.5 fade_power 2 }
light_source { <3, 3, -2> rgb <0.3, 0.4, 0.7> }
light_source { <0, 8, -8> rgb 0.15 shadowless }
plane { y, -1 pigment { rgb 0.8 } }
cylinder { -y, 0.6 * y, 0.35 pigment { rgb <0.8, 0.4, 0.3> } }
sphere { <1.2, -0.4, 1>, 0.6 pigment { rgb 0.7 } }
