// isosurface: contained by a sphere, closed, and moved, scaled.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

isosurface { function { sin(x * 4) + sin(y * 4) + sin(z * 4) } contained_by { sphere { 0, 1.2 } } max_gradient 7 accuracy 0.0005
  rotate <15, 25, 0> translate -1.5 * x pigment { rgb <0.8, 0.3, 0.2> } }
isosurface { function { abs(x) + abs(y) * 0.7 + z * z - 0.7 } contained_by { sphere { <0.1, 0, 0>, 1 } } max_gradient 3 accuracy 0.0005
  scale <1.2, 0.8, 1> rotate <20, 40, 0> translate 1.5 * x pigment { rgb <0.3, 0.7, 0.3> } }
