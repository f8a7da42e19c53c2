// material_map and quick uses of one picture to choose between textures.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0, -6> look_at 0 angle 42 }
light_source { <-5, 7, -9> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
#declare A = texture { pigment { rgb <0.8, 0.3, 0.2> } }
#declare B = texture { pigment { rgb <0.9, 0.8, 0.3> } finish { phong 0.6 phong_size 5 } }
#declare C = texture { pigment { checker rgb 1 rgb 0.2 scale 0.17 translate 0.01 } }
box { <-1.9, -0.9, 0>, <-0.1, 0.9, 0.1> texture { material_map { function 8, 8 { floor(x * 2.99) / 255 * 1.001 } texture { A } texture { B } texture { C } } scale 1.8 translate -0.9 } }
box { <0.1, -0.9, 0>, <1.9, 0.9, 0.1> texture { material_map { function 6, 6 { floor(mod(x * 7 + y * 5, 3)) / 255 * 1.001 } texture { C } texture { A } texture { B } } scale 0.9 rotate 30 * z } }
