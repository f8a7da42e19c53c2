// background: seen beside, through and mirrored in bodies; without it the sky would be black.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1, -6> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { color rgb <0.4, 0.7, 0.3> }

sphere { -1.3 * x, 1 pigment { rgbt <1, 0.4, 0.3, 0.6> } }
sphere { 1.3 * x, 1 pigment { rgb 0.1 } finish { reflection 0.8 } }
