// Wave types with frequency and phase.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

#declare Map = color_map { [0 rgb 0] [0.5 rgb <0.8, 0.3, 0.2>] [1 rgb 1] }
Tile(pigment { gradient x ramp_wave frequency 3 color_map { Map } })
Tile(pigment { gradient x triangle_wave frequency 3 color_map { Map } })
Tile(pigment { gradient x sine_wave frequency 3 color_map { Map } })
Tile(pigment { gradient x scallop_wave frequency 3 color_map { Map } })
Tile(pigment { gradient x cubic_wave frequency 3 color_map { Map } })
Tile(pigment { gradient x poly_wave 4 frequency 3 color_map { Map } })
Tile(pigment { gradient x poly_wave 0.3 frequency -2 color_map { Map } })
Tile(pigment { onion frequency 5 phase 0.3 sine_wave color_map { Map } translate 0.4 })
Tile(pigment { marble ramp_wave phase 0.7 color_map { Map } scale 0.4 })
Tile(pigment { wood frequency 2.5 phase -0.4 color_map { Map } scale 0.4 translate 0.4 })
Tile(pigment { checker frequency 0.5 scale 0.27 translate 0.013 })
Tile(pigment { radial frequency 4 phase 0.25 scallop_wave color_map { Map } rotate 90 * x translate 0.5 })
