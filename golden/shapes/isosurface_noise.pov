// isosurface: a rock made with noise from f_noise3d and a pigment function.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Noise = function { internal(76) }
#declare Dots = function { pigment { leopard color_map { [0 rgb 0] [1 rgb 1] } scale 0.1 } }
isosurface { function { sqrt(x * x + y * y + z * z) - 0.8 - 0.4 * (Noise(x * 2, y * 2, z * 2) - 0.5) } contained_by { sphere { 0, 1.1 } } max_gradient 2.5 accuracy 0.0005
  translate -1.4 * x pigment { rgb <0.7, 0.6, 0.5> } }
isosurface { function { max(abs(x), abs(y), abs(z)) - 0.7 - 0.08 * Dots(x, y, z).gray } contained_by { box { -0.9, 0.9 } } max_gradient 3 accuracy 0.0005
  rotate <20, 30, 0> translate 1.4 * x pigment { rgb <0.5, 0.6, 0.8> } }
