// isosurface: evaluate, a threshold, all_intersections in a difference, and a sphere as container.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Wave = function { y + 0.2 * sin(5 * x) * cos(4 * z) }
isosurface { function { Wave(x, y, z) } threshold 0.1 evaluate 1, 1.2, 0.95 max_gradient 2 contained_by { sphere { 0, 1 } }
  translate <-1.5, 1, 0> pigment { rgb <0.8, 0.3, 0.2> } }
difference {
  isosurface { function { max(abs(x), abs(y), abs(z)) - 0.7 } all_intersections max_gradient 1.2 }
  sphere { <0.4, 0.5, -0.6>, 0.6 }
  rotate <0, 30, 0> translate <1.5, 1, 0> pigment { rgb <0.3, 0.7, 0.3> }
}
isosurface { function { sqrt(x * x + z * z) - 0.3 - 0.2 * y * y } max_gradient 1.5 accuracy 0.0005 max_trace 3 open
  contained_by { box { <-0.8, -1, -0.8>, <0.8, 1, 0.8> } }
  rotate <20, 0, 20> translate <-1.5, -1.1, 0> pigment { rgb <0.3, 0.4, 0.9> } }
isosurface { function { sqrt(pow(sqrt(x * x + z * z) - 0.6, 2) + y * y) - 0.25 } max_gradient 1.1
  contained_by { box { -0.8, 0.8 } } inverse rotate 50 * x translate <1.5, -1.1, 0> pigment { rgb <0.9, 0.8, 0.3> } }
