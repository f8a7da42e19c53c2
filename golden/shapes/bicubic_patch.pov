// bicubic_patch: coarse and fine steps, flatness, and uv_vectors.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#macro Patch(Z) <-1, 0, -1>, <-0.3, 0.6, -1>, <0.3, -0.5, -1>, <1, 0.2, -1>
  <-1, 0.3, -0.3>, <-0.3, Z, -0.3>, <0.3, Z, -0.3>, <1, 0, -0.3>
  <-1, -0.3, 0.3>, <-0.3, Z, 0.3>, <0.3, 0.2, 0.3>, <1, -0.3, 0.3>
  <-1, 0, 1>, <-0.3, -0.4, 1>, <0.3, 0.5, 1>, <1, 0, 1> #end
bicubic_patch { type 1 flatness 0 u_steps 1 v_steps 2 Patch(1) rotate -40 * x translate <-1.5, 0.9, 0> pigment { rgb <0.8, 0.3, 0.2> } }
bicubic_patch { type 0 flatness 0 u_steps 4 v_steps 4 Patch(1.2) rotate -40 * x translate <1.5, 0.9, 0> pigment { rgb <0.3, 0.7, 0.3> } finish { phong 0.5 } }
bicubic_patch { type 1 flatness 0.05 u_steps 4 v_steps 4 Patch(0.8) rotate <-40, 30, 0> translate <-1.5, -1.2, 0> pigment { rgb <0.3, 0.4, 0.9> } }
bicubic_patch { type 1 flatness 0 u_steps 3 v_steps 3 uv_vectors <0, 0>, <1, 0>, <1, 1>, <0, 1> Patch(0.8) rotate <-40, -30, 0> translate <1.5, -1.2, 0>
  uv_mapping pigment { checker rgb 1 rgb <0.7, 0.5, 0.1> scale 0.2 translate 0.03 } }
