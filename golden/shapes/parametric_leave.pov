// parametric in a box: a half clear sheet that the ray leaves is met once.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0,10,-10> look_at 0 right 4*x up 3*y }
background { rgb <0,0,1> }
parametric {
  function { u } function { 0.05*sin(9*u) } function { v }
  <-2,-2>, <2,2>
  contained_by { box { -3, 3 } }
  accuracy 0.01 precompute 10 x,y,z
  pigment { rgbt <1,0,0,0.5> } finish { ambient 1 diffuse 0 }
}
