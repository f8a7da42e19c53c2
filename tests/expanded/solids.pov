// Transformations nest as they were written; each is as short as its bits allow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -4*z look_at 0 }
light_source { <-5, 5, -5>, <1, 0.9, 0.8> spotlight point_at 0 radius 20 falloff 30 area_light x, y, 2, 3 jitter }
difference {
  box { -1, 1 }
  sphere { 0, 1.3 rotate 30*y scale <1, 2, 1> }
  union { cylinder { -2*x, 2*x, 0.2 } torus { 1, 0.1 rotate 90*x } translate 0.1*y }
  rotate <10, 20, 0>
  clipped_by { plane { x, 0.5 } }
  bounded_by { clipped_by }
  texture { checker texture { pigment { rgb 1 } } texture { pigment { rgbt <1, 0, 0, 0.5> } finish { phong 0.5 } } scale 0.5 }
  interior { ior 1.3 media { scattering { 1, 0.2 } density { spherical color_map { [0 rgb 0] [1 rgb 1] } } } }
  hollow no_shadow inverse
}
