// Solids cut from one another, open shapes, and one solid in another.
#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 150, 30 } }
camera { location <0, 3, -6> look_at <0, 0.2, 0> right 4/3*x up y angle 45 }
light_source { <-4, 7, -5>, rgb 0.8 }
#declare Wax = texture { pigment { rgb <0.9, 0.7, 0.4> } finish { ambient 0 diffuse 0.7 subsurface { translucency <1.5, 1, 0.4> } } }
difference {
  box { <-2.2, -0.7, -0.7>, <-0.8, 0.7, 0.7> }
  sphere { <-1.5, 0.7, -0.3>, 0.6 }
  cylinder { <-1.5, -1, 0>, <-1.5, 1, 0>, 0.2 }
  texture { Wax } interior { ior 1.4 }
}
union {
  sphere { <0, -0.2, 0>, 0.5 }
  cone { <0, -0.2, 0>, 0.4, <0, 0.9, 0>, 0.1 }
  texture { Wax } interior { ior 1.4 }
}
merge {
  torus { 0.5, 0.2 translate <1.5, 0, 0> }
  cylinder { <1.5, -0.4, 0>, <1.5, 0.5, 0>, 0.15 }
  texture { Wax }
}
disc { <0, -0.71, 0>, y, 3 texture { Wax } interior { ior 1.2 } }
