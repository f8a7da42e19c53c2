// cargo run --release -- render examples/10_patterns.pov --width 960 --height 720
//
// A contact sheet of the patterns: each tile shows one as a pigment, row by row in the order below.
#version 3.7;
global_settings { assumed_gamma 1.0 }

#declare Columns = 8;
#declare Rows = 6;
camera { orthographic location <Columns / 2, -Rows / 2, -10> direction z right Columns * x up Rows * y }
background { rgb 0.02 }
#default { finish { ambient 0 diffuse 0 emission 1 } }

#declare Heat = color_map {
  [0 rgb <0.05, 0.03, 0.15>] [0.25 rgb <0.35, 0.08, 0.35>] [0.5 rgb <0.8, 0.25, 0.2>] [0.75 rgb <0.95, 0.65, 0.2>] [1 rgb <1, 0.97, 0.8>]
}
#declare N = 0;
#macro Tile(P)
  box {
    <-0.46, -0.46, 0>, <0.46, 0.46, 0.1>
    pigment { P }
    translate <mod(N, Columns) + 0.5, -int(N / Columns) - 0.5, 0>
  }
  #declare N = N + 1;
#end

// Patterns that are formulas.
Tile(pigment { boxed color_map { Heat } scale 0.5 rotate 15 })
Tile(pigment { cylindrical color_map { Heat } scale 0.5 rotate 70 * x })
Tile(pigment { planar color_map { Heat } scale 0.5 rotate 30 * z })
Tile(pigment { spherical color_map { Heat } scale 0.55 })
Tile(pigment { gradient <1, 1, 0> color_map { Heat } scale 0.35 })
Tile(pigment { onion color_map { Heat } scale 0.2 })
Tile(pigment { leopard color_map { Heat } scale 0.035 })
Tile(pigment { radial color_map { Heat } frequency 3 rotate 90 * x })
Tile(pigment { wood color_map { Heat } scale 0.15 turbulence 0.05 })
Tile(pigment { marble color_map { Heat } scale 0.25 turbulence 0.6 })
Tile(pigment { spiral1 4 color_map { Heat } scale 0.3 })
Tile(pigment { spiral2 5 color_map { Heat } scale 0.3 })
Tile(pigment { quilted color_map { Heat } scale 0.22 })
Tile(pigment { ripples color_map { Heat } scale 0.08 })
Tile(pigment { waves color_map { Heat } scale 0.08 })
Tile(pigment { function { 0.5 + 0.5 * sin(40 * x * y) * cos(12 * (x - y)) } color_map { Heat } })
// Noise.
Tile(pigment { bozo color_map { Heat } scale 0.12 })
Tile(pigment { bumps color_map { Heat } scale 0.06 })
Tile(pigment { dents color_map { Heat } scale 0.08 })
Tile(pigment { granite color_map { Heat } scale 0.6 })
Tile(pigment { wrinkles color_map { Heat } scale 0.3 })
Tile(pigment { agate color_map { Heat } scale 0.4 })
Tile(pigment { cells color_map { Heat } scale 0.12 translate 0.013 })
Tile(pigment { crackle color_map { Heat } scale 0.2 })
Tile(pigment { crackle form <1, 0, 0> color_map { Heat } scale 0.2 })
Tile(pigment { crackle solid color_map { Heat } scale 0.2 })
// Fractals.
Tile(pigment { mandel 40 color_map { Heat } scale 0.33 translate 0.2 * x })
Tile(pigment { julia <0.353, 0.288>, 30 color_map { Heat } scale 0.33 })
Tile(pigment { mandel 30 exponent 4 color_map { Heat } interior 1, 0.8 scale 0.33 })
Tile(pigment { magnet 1 mandel 30 color_map { Heat } scale 0.18 translate -0.25 * x })
Tile(pigment { magnet 2 mandel 30 color_map { Heat } scale 0.2 translate -0.25 * x })
Tile(pigment { magnet 1 julia <1.3, 0.4>, 30 color_map { Heat } scale 0.18 })
// Blocks and tilings.
Tile(pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.35, 0.08, 0.3> scale 0.15 translate 0.013 })
Tile(pigment { brick rgb 0.8 rgb <0.6, 0.18, 0.1> scale 0.05 translate 0.013 })
Tile(pigment { hexagon rgb <0.95, 0.7, 0.2> rgb <0.35, 0.1, 0.35> rgb <0.8, 0.28, 0.2> scale 0.12 rotate 90 * x })
Tile(pigment { square rgb <0.95, 0.7, 0.2> rgb <0.35, 0.1, 0.35> rgb <0.8, 0.28, 0.2> rgb 0.9 scale 0.15 rotate 90 * x translate 0.013 })
Tile(pigment { triangular rgb 0.9 rgb <0.95, 0.7, 0.2> rgb <0.8, 0.28, 0.2> rgb <0.6, 0.15, 0.3> rgb <0.35, 0.1, 0.35> rgb <0.1, 0.05, 0.2> scale 0.22 rotate 90 * x })
Tile(pigment { cubic rgb 0.9 rgb <0.95, 0.7, 0.2> rgb <0.8, 0.28, 0.2> rgb <0.6, 0.15, 0.3> rgb <0.35, 0.1, 0.35> rgb <0.1, 0.05, 0.2> rotate <30, 40, 0> translate 0.1 })
Tile(pigment { tiling 8 color_map { Heat } scale 0.16 rotate 90 * x })
Tile(pigment { tiling 22 color_map { Heat } scale 0.12 rotate 90 * x })
Tile(pigment { tiling 25 color_map { Heat } scale 0.07 rotate 90 * x })
Tile(pigment { tiling 27 color_map { Heat } scale 0.14 rotate 90 * x translate 0.3 })
Tile(pigment { pavement number_of_sides 3 number_of_tiles 6 pattern 5 color_map { Heat } scale 0.17 rotate 90 * x })
Tile(pigment { pavement number_of_sides 4 number_of_tiles 5 pattern 7 color_map { Heat } scale 0.14 rotate 90 * x translate 0.013 })
Tile(pigment { pavement number_of_sides 6 number_of_tiles 3 pattern 2 form 2 color_map { Heat } scale 0.14 rotate 90 * x })
Tile(pigment { pavement number_of_sides 6 number_of_tiles 5 pattern 20 form 1 color_map { Heat } scale 0.14 rotate 90 * x })
Tile(pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.35, 0.08, 0.3> scale <0.06, 0.1, 1> warp { spherical orientation y } })
Tile(pigment { gradient y color_map { Heat } scale 0.2 warp { black_hole <0.1, 0, 0>, 0.42 falloff 1.2 strength 1.6 inverse } })
