// several fogs: a filtering one, one that never hides all, a ground fog along another up.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.4, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <-5, 9, -6> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.7>] [1 rgb <0.2, 0.4, 0.8>] } } }
fog { distance 40 rgbf <0.3, 0.4, 0.5, 0.3> }
fog { distance 25 rgbt <0.3, 0.25, 0.2, 0.4> }
fog { fog_type 2 distance 14 rgb <0.4, 0.4, 0.45> fog_offset 0.2 fog_alt 0.6 up <0.3, 1, 0> }
plane { y, 0 pigment { checker rgb <0.3, 0.5, 0.2> rgb <0.4, 0.3, 0.2> translate 0.1 } }
sphere { <-1.2, 0.7, 0>, 0.7 pigment { rgb <0.8, 0.2, 0.2> } }
sphere { <1.5, 1, 6>, 1 pigment { rgb <0.2, 0.3, 0.8> } finish { reflection 0.4 } }
cylinder { <0.4, 0, 2>, <0.4, 3, 2>, 0.3 pigment { rgb <0.9, 0.7, 0.2> } }
