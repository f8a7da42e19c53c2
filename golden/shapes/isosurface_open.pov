// isosurface: open leaves holes where the container cuts; max_trace lets CSG see every sheet.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

isosurface { function { y - 0.3 * sin(x * 4) * cos(z * 4) } open contained_by { box { -1, 1 } } max_gradient 1.8 accuracy 0.0005
  rotate -30 * x translate -1.5 * x pigment { rgb <0.8, 0.5, 0.2> } }
difference {
  isosurface { function { abs(sqrt(x * x + y * y + z * z) - 0.8) - 0.1 } contained_by { box { -1, 1 } } max_gradient 1.1 max_trace 4 accuracy 0.0005 }
  box { <0, 0, -2>, 2 pigment { rgb <0.9, 0.8, 0.3> } }
  translate 1.5 * x
  pigment { rgb <0.3, 0.4, 0.9> }
}
