// height_field: heights from a function image, flat faces.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0.5, 1.3, -1.3> look_at <0.5, 0.1, 0.5> angle 45 }
light_source { <-3, 4, -2> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
height_field { function 24, 24 { 0.5 + 0.3 * sin(x * 9) * cos(y * 7) + 0.1 * x } scale <1, 0.6, 1> pigment { rgb <0.7, 0.6, 0.4> } }
