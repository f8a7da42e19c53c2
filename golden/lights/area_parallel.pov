// parallel area lights, and an area light through a window.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 4.5, -7> look_at <0, 0.2, 0.3> angle 44 }
plane { y, 0 pigment { rgb 0.85 } }
sphere { <-1.2, 0.5, 0.4>, 0.5 pigment { rgb <0.9, 0.8, 0.7> } finish { phong 0.5 } }
cylinder { <0.1, 0, 0.2>, <0.1, 1, 0.2>, 0.25 pigment { rgb <0.8, 0.5, 0.3> } }
box { <1.1, 0, 0>, <1.8, 0.8, 0.8> pigment { rgb <0.5, 0.6, 0.8> } }
light_source { <-3, 5, -3> rgb 0.4 parallel point_at 0 area_light 1.5 * x, 1.5 * z, 4, 4 }
light_source { <3, 4, -3> rgb 0.7 area_light 0.8 * x, 0.8 * y, 5, 5 projected_through { disc { <1.6, 2.2, -1.5>, <3, 4, -3>, 0.9 } } }
