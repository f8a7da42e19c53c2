// projected_through: light only through a window, whose shape stands on the floor.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4.5, -7> look_at <0, 0.2, 0.3> angle 44 }
plane { y, 0 pigment { rgb 0.85 } }
sphere { <-1.2, 0.5, 0.4>, 0.5 pigment { rgb <0.9, 0.8, 0.7> } finish { phong 0.5 } }
cylinder { <0.1, 0, 0.2>, <0.1, 1, 0.2>, 0.25 pigment { rgb <0.8, 0.5, 0.3> } }
box { <1.1, 0, 0>, <1.8, 0.8, 0.8> pigment { rgb <0.5, 0.6, 0.8> } }

light_source { <-2, 5, -3> rgb 1.1 projected_through { difference { box { <-1.6, 2.4, -2.6>, <1.2, 2.5, 0.4> } box { <-0.7, 2, -1.4>, <-0.3, 3, -0.9> } } } }
light_source { <0, 5, -8> rgb 0.15 shadowless }
