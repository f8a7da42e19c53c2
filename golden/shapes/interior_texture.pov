// interior_texture: the inner side of an open cylinder, of clipped shells and of a plane.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

cylinder { -y, y, 0.7 open rotate <50, 0, 20> translate -1.8 * x texture { pigment { rgb <0.8, 0.3, 0.2> } } interior_texture { pigment { rgb <0.9, 0.9, 0.3> } } }
sphere { 0, 1 clipped_by { plane { <0, 1, 0.4>, 0.2 } } rotate -30 * x texture { pigment { rgb <0.3, 0.7, 0.3> } }
  interior_texture { pigment { checker rgb 1 rgb <0.6, 0.1, 0.5> scale 0.3 } } }
torus { 0.7, 0.3 clipped_by { plane { z, 0 } } rotate <-40, 20, 0> translate 1.9 * x texture { pigment { rgb <0.3, 0.4, 0.9> } finish { phong 0.5 } } interior_texture { pigment { rgb <1, 0.5, 0.1> } } }
