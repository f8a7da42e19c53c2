// fade_distance and fade_power for a point, a spot and a cylinder light.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4.5, -7> look_at <0, 0.2, 0.3> angle 44 }
plane { y, 0 pigment { rgb 0.85 } }
sphere { <-1.2, 0.5, 0.4>, 0.5 pigment { rgb <0.9, 0.8, 0.7> } finish { phong 0.5 } }
cylinder { <0.1, 0, 0.2>, <0.1, 1, 0.2>, 0.25 pigment { rgb <0.8, 0.5, 0.3> } }
box { <1.1, 0, 0>, <1.8, 0.8, 0.8> pigment { rgb <0.5, 0.6, 0.8> } }

light_source { <-2, 1.2, -0.6> rgb <1, 0.7, 0.5> fade_distance 0.8 fade_power 2 }
light_source { <2, 3, -0.5> rgb <0.6, 0.8, 1> spotlight point_at <1.6, 0, 0.2> radius 20 falloff 35 fade_distance 2 fade_power 4 }
light_source { <0, 2.6, 1> rgb 0.7 fade_distance 1.5 fade_power 1 }
