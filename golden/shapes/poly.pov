// poly: order 2, 5 and 6.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

poly { 2, <1, 0, 0, 0, 1, 0.5, 0, 1, 0, -0.8> translate -2.1 * x pigment { rgb <0.8, 0.3, 0.2> } }
intersection {
  polynomial { 5, xyz(5,0,0): 1, xyz(0,3,0): -1, xyz(1,2,0): 0.5, xyz(0,0,2): -0.6, xyz(0,1,0): 0.8 }
  sphere { 0, 1 }
  rotate 30 * y
  pigment { rgb <0.9, 0.8, 0.3> }
}
polynomial { 6, xyz(6,0,0): 1, xyz(0,6,0): 1, xyz(0,0,6): 1, xyz(2,2,2): 3, xyz(0,0,0): -0.6
  rotate <20, 30, 10> translate 2.1 * x pigment { rgb <0.3, 0.4, 0.9> } finish { phong 0.6 } }
