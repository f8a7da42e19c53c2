// clipped_by: shells without caps, cut by a plane, a box and an inverted sphere.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -7> look_at 0 angle 40 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

sphere { 0, 1 clipped_by { plane { <0.3, 1, -0.2>, 0.3 } } translate -2.2 * x pigment { rgb <0.8, 0.3, 0.2> } }
cylinder { -y, y, 0.7 clipped_by { box { <-2, -0.6, -2>, <2, 0.6, 0.4> } } pigment { rgb <0.3, 0.7, 0.3> } }
box { -0.8, 0.8 clipped_by { sphere { <0, 0.6, -0.6>, 0.9 inverse } } rotate 20 * y translate 2.2 * x
  pigment { rgb <0.3, 0.4, 0.9> } }
