// quadric: ellipsoid, one-sheet hyperboloid, paraboloid and a slanted cylinder, cut by boxes.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

quadric { <1, 2, 1.5>, <0.3, 0, 0.2>, 0, -0.8 translate <-1.7, 1, 0> pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.5 } }
intersection { quadric { <1, -0.7, 1>, 0, 0, -0.25 } box { <-2, -0.9, -2>, <2, 0.9, 2> } translate <1.4, 1, 0> pigment { rgb <0.3, 0.7, 0.3> } }
intersection { quadric { <1, 0, 1>, 0, <0, -1, 0>, 0 } plane { y, 1 } translate <-1.3, -1.3, 0> pigment { rgb <0.3, 0.4, 0.9> } }
intersection { quadric { <1, 0.5, 0>, <1, 0, 0>, 0, -0.3 } box { -1, 1 } rotate 40 * y translate <1.4, -1, 0> pigment { rgb <0.9, 0.8, 0.3> } }
