// Solids of shapes with all kinds of insides: prism, lathe, sor, blob, sweep, text, mesh, isosurface, julia.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Red = texture { pigment { rgb <0.8, 0.3, 0.2> } }
#declare Gold = texture { pigment { rgb <0.9, 0.8, 0.3> } finish { phong 0.5 } }
difference {
  prism { cubic_spline -0.4, 0.4, 8, <-0.9, 0.3>, <-0.6, -0.7>, <0.3, -0.4>, <0.8, -0.8>, <0.7, 0.7>, <-0.9, 0.3>, <-0.6, -0.7>, <0.3, -0.4> }
  sphere { <0, 0.4, -0.2>, 0.5 texture { Gold } }
  rotate -30 * x translate <-2, 1.2, 0> texture { Red }
}
intersection {
  lathe { cubic_spline 6, <0.2, -1>, <0.1, -0.8>, <0.9, -0.3>, <0.4, 0.4>, <0.1, 0.8>, <0, 1> }
  box { <-1, -1, -1>, <1, 0.3, 0.2> texture { Gold } }
  rotate <-20, 160, 0> translate <0, 1.2, 0> texture { Red }
}
difference {
  blob { threshold 0.5 sphere { -0.4 * x, 0.9, 1 } sphere { 0.4 * x, 0.8, 1 } }
  cylinder { -2 * z, 2 * z, 0.25 texture { Gold } }
  rotate 25 * y translate <2, 1.2, 0> texture { Red }
}
difference {
  sphere_sweep { linear_spline 3, <-0.7, -0.4, 0>, 0.3, <0, 0.5, 0>, 0.25, <0.7, -0.3, 0>, 0.35 }
  plane { z, -0.05 texture { Gold } }
  translate <-2, -0.9, 0> texture { Red }
}
merge {
  sor { 5, <0.4, -1>, <0.5, -0.7>, <0.8, 0>, <0.2, 0.7>, <0.1, 1> }
  torus { 0.75, 0.2 texture { Gold } }
  rotate -20 * x translate <0, -0.9, 0> texture { Red }
}
intersection {
  isosurface { function { x * x + y * y * 2 + z * z - 0.5 + 0.1 * sin(10 * x) } max_gradient 4 max_trace 4 }
  box { <-1, -1, -0.3>, <1, 1, 1> texture { Gold } }
  rotate <10, 35, 0> translate <2, -0.9, 0> texture { Red }
}
