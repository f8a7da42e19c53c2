// quartic: the rounded cube x^4 + y^4 + z^4 = 1 and a torus written as a quartic with sturm.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

quartic { <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -1>
  rotate <25, 35, 0> translate -1.4 * x pigment { rgb <0.8, 0.3, 0.2> } finish { specular 0.4 } }
// (x^2 + y^2 + z^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2) with R = 0.8, r = 0.3.
#declare K = 0.64 - 0.09;
polynomial { 4, xyz(4,0,0): 1, xyz(0,4,0): 1, xyz(0,0,4): 1, xyz(2,2,0): 2, xyz(2,0,2): 2, xyz(0,2,2): 2,
  xyz(2,0,0): 2 * K - 2.56, xyz(0,2,0): 2 * K, xyz(0,0,2): 2 * K - 2.56, xyz(0,0,0): K * K sturm
  rotate <60, 0, 15> translate 1.4 * x pigment { rgb <0.3, 0.7, 0.3> } }
