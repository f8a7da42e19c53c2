// Objects that glow light others; no light source at all.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 200 max_sample 2 } }

camera { location <0, 3, -6> look_at <0, 0.7, 0> right 4/3*x up y angle 45 }
plane { y, 0 pigment { rgb 0.8 } finish { diffuse 0.9 } }
plane { z, 3 pigment { rgb 0.8 } finish { diffuse 0.9 } }
box { <-2.5, 1.2, -1>, <-0.8, 1.4, 1> pigment { rgb <1, 0.7, 0.4> } finish { diffuse 0 emission 1.5 } }
sphere { <1.4, 1.1, 0.3>, 0.7 pigment { rgb <0.4, 0.6, 1> } finish { diffuse 0 emission 0.8 } }
cylinder { <0, 0, -1>, <0, 0.8, -1>, 0.4 pigment { rgb 0.9 } finish { diffuse 0.8 } }
