// cargo run --release -- render examples/11_normals.pov --width 960 --height 720
//
// A contact sheet of the normals: the same ball, bent by one pattern each.
#version 3.7;
global_settings { assumed_gamma 1.0 }

#declare Columns = 6;
#declare Rows = 4;
camera { orthographic location <Columns / 2, -Rows / 2, -10> direction z right (Columns + 0.1) * x up (Rows + 0.1) * y * Columns / Rows * 3 / 4 }
light_source { <-100, 120, -140> rgb <1, 0.97, 0.92> }
light_source { <150, 10, -60> rgb <0.12, 0.16, 0.28> }
background { rgb <0.03, 0.03, 0.04> }
#default { pigment { rgb <0.72, 0.68, 0.62> } finish { ambient 0.03 diffuse 0.8 specular 0.35 roughness 0.03 } }

#declare N = 0;
#macro Ball(B)
  sphere { 0, 0.46 normal { B } translate <mod(N, Columns) + 0.5, -int(N / Columns) - 0.5, 0> }
  #declare N = N + 1;
#end

Ball(normal { bumps 0.7 scale 0.08 })
Ball(normal { dents 1.4 scale 0.08 })
Ball(normal { wrinkles 0.9 scale 0.2 })
Ball(normal { quilted 0.9 control0 0.5 control1 1 scale 0.2 })
Ball(normal { ripples 2.5 scale 0.12 })
Ball(normal { waves 1 scale 0.15 })
Ball(normal { onion 1.2 sine_wave scale 0.1 translate 0.3 })
Ball(normal { wood 1.2 sine_wave scale 0.13 turbulence 0.05 })
Ball(normal { marble 1 turbulence 0.5 scale 0.2 })
Ball(normal { leopard 1.5 scale 0.03 })
Ball(normal { granite 0.5 scale 0.5 })
Ball(normal { crackle 2 scale 0.18 })
Ball(normal { gradient y, 1.2 triangle_wave scale 0.12 })
Ball(normal { radial 1.5 sine_wave frequency 16 })
Ball(normal { spiral1 6, 1.5 scale 0.3 rotate 30 * y })
Ball(normal { agate 0.8 scale 0.4 })
Ball(normal { hexagon 2 accuracy 0.15 scale 0.13 rotate 60 * x })
Ball(normal { brick 2 accuracy 0.35 scale 0.035 })
Ball(normal { tiling 22, 2.5 scale 0.12 rotate 70 * x })
Ball(normal { cells 2 accuracy 0.08 scale 0.15 translate 0.013 })
Ball(normal { facets size 0.35 })
Ball(normal { gradient y, 2.5 slope_map { [0 <0, 1>] [0.3 <0.5, 0>] [0.5 <0.5, 0>] [0.8 <0, -1>] [1 <0, 0>] } scale 0.2 })
Ball(normal { checker normal { bumps 0.8 scale 0.1 } normal { gradient y, 1.5 sine_wave scale 0.2 } scale 0.25 translate 0.013 })
Ball(normal { average normal_map { [1 quilted 1 scale 0.25] [1 bumps 1 scale 0.06] } })
