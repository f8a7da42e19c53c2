// cargo run --release -- render examples/05_chess.pov
//
// Turned wood: pawns, a bishop and a rook from lathes and CSG, on a board made of one checker.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
  location <-3.6, 4.4, -7.8>
  look_at <0.1, 0.7, 0.2>
  right x * image_width / image_height
  angle 40
}

light_source { <-7, 10, -3> rgb <1, 0.95, 0.88> area_light 2 * x, 2 * z, 5, 5 adaptive 1 }
light_source { <6, 5, -9> rgb 0.18 shadowless }
background { rgb <0.16, 0.14, 0.13> }

#macro Wood(Dark, Light)
  texture {
    pigment { wood color_map { [0 rgb Light] [0.8 rgb Dark] [1 rgb Dark * 0.8] } turbulence 0.08 octaves 3 scale 0.22 rotate 86 * x }
    finish { specular 0.4 roughness 0.02 reflection { 0.01, 0.2 } }
  }
#end

// The board: fields, and a frame that stands a little below them.
box {
  <-4, -0.2, -4>, <4, 0, 4>
  pigment { checker rgb <0.78, 0.66, 0.48> rgb <0.25, 0.13, 0.07> translate <0, 0.5, 0> }
  finish { reflection { 0.02, 0.25 } specular 0.3 }
}
box { <-4.5, -0.5, -4.5>, <4.5, -0.05, 4.5> Wood(<0.22, 0.11, 0.05>, <0.35, 0.19, 0.1>) }

#declare Pawn = union {
  lathe {
    cubic_spline
    11, <0.3, -0.1>, <0.38, 0>, <0.38, 0.1>, <0.24, 0.2>, <0.2, 0.3>, <0.12, 0.55>, <0.11, 0.68>, <0.22, 0.74>, <0.2, 0.79>, <0.08, 0.81>, <0, 0.81>
  }
  sphere { <0, 0.97, 0>, 0.2 }
}
#declare Bishop = union {
  lathe {
    cubic_spline
    11, <0.3, -0.1>, <0.42, 0>, <0.42, 0.12>, <0.26, 0.24>, <0.2, 0.4>, <0.12, 0.9>, <0.12, 1.05>, <0.26, 1.12>, <0.22, 1.18>, <0.1, 1.22>, <0, 1.22>
  }
  difference {
    sphere { 0, 0.25 scale <1, 1.35, 1> }
    box { <-1, -0.03, -1>, <1, 0.03, 1> rotate 45 * z translate <0.22, 0.18, 0> }
    translate 1.46 * y
  }
  sphere { <0, 1.84, 0>, 0.07 }
}
#declare Rook = difference {
  lathe {
    cubic_spline
    12, <0.3, -0.1>, <0.44, 0>, <0.44, 0.12>, <0.3, 0.24>, <0.23, 0.4>, <0.2, 0.9>, <0.22, 1>, <0.34, 1.06>, <0.34, 1.34>, <0.24, 1.34>, <0.24, 1.2>, <0, 1.2>
  }
  #for (K, 0, 2)
    box { <-1, 1.22, -0.06>, <1, 2, 0.06> rotate 60 * K * y }
  #end
}

#declare White = Wood(<0.75, 0.58, 0.36>, <0.9, 0.76, 0.54>)
#declare Black = Wood(<0.12, 0.06, 0.04>, <0.24, 0.12, 0.07>)

object { Pawn texture { White } translate <-1.5, 0, -1.5> }
object { Pawn texture { White } translate <0.5, 0, -2.5> }
object { Pawn texture { White } translate <2.5, 0, -1.5> }
object { Bishop texture { White } rotate 30 * y translate <-0.5, 0, -0.5> }
object { Rook texture { White } translate <2.5, 0, 0.5> }
object { Pawn texture { Black } translate <-2.5, 0, 1.5> }
object { Pawn texture { Black } translate <1.5, 0, 1.5> }
object { Bishop texture { Black } rotate -50 * y translate <0.5, 0, 2.5> }
object { Rook texture { Black } translate <-1.5, 0, 3.5> }
