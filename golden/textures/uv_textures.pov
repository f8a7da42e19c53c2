// uv_mapping within textures, over a sphere, torus, lathe and box: pigment and normal.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
sphere { 0, 0.95 pigment { uv_mapping checker rgb 1 rgb <0.7, 0.2, 0.2> scale <0.0625, 0.125, 1> translate 0.003 } rotate <-20, 0, 10> translate <-1.5, 1.1, 0> }
torus { 0.65, 0.3 texture { uv_mapping pigment { gradient y color_map { [0 rgb <0.2, 0.5, 0.8>] [1 rgb 1] } scale 0.21 } finish { phong 0.6 } } rotate -55 * x translate <1.5, 1.1, 0> }
lathe { linear_spline 4, <0.3, -0.9>, <0.9, -0.4>, <0.4, 0.4>, <0.7, 0.9> pigment { uv_mapping checker rgb <0.9, 0.8, 0.4> rgb <0.2, 0.3, 0.5> scale 0.11 } translate <-1.5, -1.1, 0> }
box { -0.65, 0.65 pigment { uv_mapping checker rgb <0.9, 0.8, 0.4> rgb <0.4, 0.1, 0.3> scale 0.083 translate 0.002 } rotate <25, 30, 0> translate <1.5, -1.1, 0> }
