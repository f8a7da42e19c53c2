// uv_mapping: sphere, box, torus, cone without uv of its own, mesh2 with uv_vectors.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Map = pigment { gradient x color_map { [0 rgb <0.9, 0.2, 0.1>] [0.1 rgb <0.9, 0.2, 0.1>] [0.1 rgb <0.2, 0.4, 0.8>] [1 rgb <0.9, 0.9, 0.6>] } scale <0.25, 1, 1> translate 0.013 }
sphere { 0, 0.9 uv_mapping pigment { Map } rotate 20 * z translate <-1.5, 1, 0> }
torus { 0.6, 0.3 uv_mapping pigment { Map } rotate -50 * x translate <1.4, 1, 0> }
box { -0.6, 0.6 uv_mapping pigment { Map } rotate <25, 30, 0> translate <-1.5, -1.1, 0> }
mesh2 {
  vertex_vectors { 4, <-0.8, -0.7, 0>, <0.9, -0.5, 0.2>, <0.6, 0.8, 0>, <-0.7, 0.6, -0.2> }
  uv_vectors { 4, <0, 0>, <1, 0.2>, <0.8, 1>, <0.1, 0.9> }
  face_indices { 2, <0, 1, 2>, <0, 2, 3> }
  uv_indices { 2, <0, 1, 2>, <0, 2, 3> }
  uv_mapping pigment { Map rotate 30 * z }
  translate <1.4, -1.1, 0>
}
