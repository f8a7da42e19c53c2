// A smooth mesh and a bumpy cone mirrored by negative scales: normals must follow.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1, -8> look_at 0 angle 38 }
light_source { <-6, 5, -8> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Wing = mesh {
  smooth_triangle { <0, 0, 0>, <-0.3, 0, -1>, <1.6, 0.2, 0>, <0.5, 0.2, -1>, <0.6, 1.2, 0.4>, <0.2, 0.9, -1> }
  smooth_triangle { <0, 0, 0>, <-0.3, 0, -1>, <1.6, 0.2, 0>, <0.5, 0.2, -1>, <0.8, -1.1, 0.4>, <0, -0.8, -1> }
  pigment { rgb <0.5, 0.7, 0.3> }
  finish { specular 0.5 roughness 0.05 }
}
#declare Post = cone { <0, -1.2, 0>, 0.3, <0.2, 1.2, 0>, 0.05 pigment { gradient y color_map { [0 rgb 1] [0.5 rgb <0.6, 0.3, 0.1>] } scale 0.4 } }

object { Wing translate 0.25 * x }
object { Wing translate 0.25 * x scale <-1, 1, 1> }
object { Post translate 2.1 * x }
object { Post translate 2.1 * x scale -1 }
