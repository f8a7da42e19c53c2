// A block and a ball of one material under a lamp from the side.
#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 200, 40 } }
camera { location <0, 2, -5> look_at <0, 0.6, 0> right 4/3*x up y angle 45 }
light_source { <-6, 6, -4>, rgb 0.9 }
#declare Marble = texture {
  pigment { rgb <0.83, 0.79, 0.75> }
  finish { ambient 0 diffuse 0.8 specular 0.3 subsurface { translucency <0.46, 0.38, 0.33> } }
}
plane { y, 0 pigment { checker rgb 0.5 rgb 0.7 } finish { diffuse 0.7 } }
box { <-1.5, 0, -0.4>, <-0.3, 1.2, 0.6> texture { Marble } interior { ior 1.5 } rotate -15*y }
sphere { <0.8, 0.7, 0>, 0.7 texture { Marble } interior { ior 1.5 } }
