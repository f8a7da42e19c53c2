// isosurface: internal functions and operators that bounds along rays are known of; a wave with kinks.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Torus = function { internal(70) }
#declare Heart = function { internal(23) }
isosurface { function { Torus(x, y, z, 0.7, 0.25) + 0.05 * sin(12 * x) } max_gradient 1.8 contained_by { box { -1.2, 1.2 } }
  rotate -40 * x translate -1.5 * x pigment { rgb <0.8, 0.5, 0.2> } }
isosurface { function { Heart(x, y, z, -1) } max_gradient 30 contained_by { box { -1.4, 1.4 } } rotate -90 * x rotate 20 * y
  translate <1.2, 0, 0> pigment { rgb <0.9, 0.3, 0.3> } }
isosurface { function { y + 0.1 * abs(mod(x, 0.8)) + max(x * x, z * z) * 0.1 + 1.2 } max_gradient 1.6
  contained_by { box { <-3, -2, -2>, <3, 0, 2> } } pigment { rgb <0.4, 0.6, 0.4> } }
