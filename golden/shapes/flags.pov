// no_shadow, no_image and no_reflection: each ball lacks one of the three.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -7> look_at <0, 0.3, 0.5> angle 40 }
light_source { <-3, 7, -4> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -0.8 pigment { rgb <0.7, 0.7, 0.6> } }
plane { z, 3 pigment { rgb 0.1 } finish { reflection 0.7 } }
sphere { <-2, 0.2, 0>, 0.7 pigment { rgb <0.8, 0.3, 0.2> } no_shadow }
sphere { <0, 0.2, 0>, 0.7 pigment { rgb <0.3, 0.7, 0.3> } no_image }
sphere { <2, 0.2, 0>, 0.7 pigment { rgb <0.9, 0.8, 0.3> } no_reflection }
