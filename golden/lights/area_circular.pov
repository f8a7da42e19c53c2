// circular and orient: the grid bent into a disc, and turned to face each point.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 4.5, -7> look_at <0, 0.2, 0.3> angle 44 }
plane { y, 0 pigment { rgb 0.85 } }
sphere { <-1.2, 0.5, 0.4>, 0.5 pigment { rgb <0.9, 0.8, 0.7> } finish { phong 0.5 } }
cylinder { <0.1, 0, 0.2>, <0.1, 1, 0.2>, 0.25 pigment { rgb <0.8, 0.5, 0.3> } }
box { <1.1, 0, 0>, <1.8, 0.8, 0.8> pigment { rgb <0.5, 0.6, 0.8> } }
light_source { <-2, 3, -2> rgb 0.5 area_light 1.4 * x, 1.4 * z, 5, 5 circular }
light_source { <2.5, 3, -2> rgb 0.5 area_light 1.2 * x, 1.2 * y, 5, 5 circular orient adaptive 1 }
