// A scene of thousands.
#version 3.7;
global_settings { assumed_gamma 1 radiosity {  } }
camera { location <0, 1.5, -4.5> * 1000 look_at <0, 1.2, 0> * 1000 right 4/3*x up y angle 65 }

#declare Wall = finish { diffuse 0.8 }
background { rgb <0.5, 0.6, 0.8> }
union {
  box { <-2, 0, -1>, <2, 0.1, 2> pigment { rgb 0.9 } }
  box { <-2, 0, 1.9>, <2, 3, 2> pigment { rgb <0.9, 0.4, 0.2> } }
  sphere { <0.6, 0.9, 0.4>, 0.8 pigment { rgb 0.8 } }
  finish { Wall }
  scale 1000
}
