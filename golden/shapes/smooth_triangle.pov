// smooth_triangle: a fan with normals that bend more than the face, transformed and inside a union.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#macro Fan()
union {
  #for (K, 0, 5)
    #declare A = K * pi / 3;
    #declare B = (K + 1) * pi / 3;
    smooth_triangle { <0, 0.3, 0>, y, <cos(A), 0, sin(A)>, <cos(A), 0.6, sin(A)>, <cos(B), 0, sin(B)>, <cos(B), 0.6, sin(B)> }
  #end
  pigment { rgb <0.8, 0.6, 0.3> }
  finish { specular 0.6 roughness 0.03 }
}
#end
object { Fan() rotate -50 * x scale 1.2 translate -1.4 * x }
object { Fan() rotate -50 * x scale <0.6, 1.4, 1> rotate 30 * z translate 1.4 * x }
