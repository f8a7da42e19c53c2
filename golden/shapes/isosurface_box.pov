// isosurface: contained by a box that cuts it and closes it; a threshold.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

isosurface { function { sqrt(x * x + y * y + z * z) - 0.9 + 0.1 * sin(8 * x) * sin(8 * y) } contained_by { box { -0.8, 0.95 } } max_gradient 2.2 accuracy 0.0005
  rotate <15, 25, 0> translate -1.5 * x pigment { rgb <0.8, 0.5, 0.2> } }
isosurface { function { x * x + y * y * 2 - z * 0.5 } threshold 0.5 contained_by { box { -1, 1 } } max_gradient 5 accuracy 0.0005
  rotate <20, -35, 0> translate 1.5 * x pigment { rgb <0.3, 0.6, 0.8> } }
