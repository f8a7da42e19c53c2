// area_illumination where part of the lamp is below the surface's horizon.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 4.5, -7> look_at <0, 0.2, 0.3> angle 44 }
plane { y, 0 pigment { rgb 0.85 } }
sphere { <-1.2, 0.5, 0.4>, 0.5 pigment { rgb <0.9, 0.8, 0.7> } finish { phong 0.5 } }
cylinder { <0.1, 0, 0.2>, <0.1, 1, 0.2>, 0.25 pigment { rgb <0.8, 0.5, 0.3> } }
box { <1.1, 0, 0>, <1.8, 0.8, 0.8> pigment { rgb <0.5, 0.6, 0.8> } }
light_source { <0.3, 0.4, 0.1> rgb 0.9 area_light 3.5 * x, 1.7 * y, 7, 4 area_illumination on fade_distance 2 fade_power 1 }
light_source { <0, 6, 3> rgb 0.4 }
