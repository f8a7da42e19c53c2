// A #default that holds for some objects stands before them, and all textures ahead of it.
#version 3.6;
global_settings { assumed_gamma 2.2 }
camera { location -4*z look_at 0 }
light_source { -9*z, 1 }
sphere { -x, 0.5 }
#default { pigment { rgb <1, 0.5, 0> } finish { ambient 0.4 diffuse albedo 0.5 } }
sphere { 0, 0.5 }
sphere { x, 0.5 finish { reflection { 0.2 fresnel } conserve_energy } normal { bumps 0.3 scale 0.1 } }
mesh {
  triangle { <0, 1, 0>, <1, 1, 0>, <0, 2, 0> }
  smooth_triangle { <0, 1, 0>, -z, <-1, 1, 0>, -z, <0, 2, 0>, <0.1, 0, -1> }
}
