// mesh: an octahedron of triangles with textures of their own, and an inside by inside_vector.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.2, -6> look_at 0 angle 40 }
light_source { <-5, 6, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Red = texture { pigment { rgb <0.8, 0.3, 0.2> } }
#declare Gold = texture { pigment { rgb <0.9, 0.7, 0.2> } finish { phong 0.5 } }
#declare Gem = mesh {
  #for (K, 0, 3)
    #declare A = <cos(K * pi / 2), 0, sin(K * pi / 2)>;
    #declare B = <cos((K + 1) * pi / 2), 0, sin((K + 1) * pi / 2)>;
    triangle { A, B, y texture { Red } }
    triangle { A, B, -y #if (mod(K, 2) = 0) texture { Gold } #end }
  #end
  inside_vector z
  texture { pigment { rgb <0.3, 0.4, 0.9> } }
}
object { Gem rotate <10, 25, 0> scale 1.1 translate -1.4 * x }
difference {
  object { Gem }
  sphere { <0.2, 0.3, -0.8>, 0.6 pigment { rgb <0.5, 0.9, 0.5> } }
  rotate <0, 15, 10>
  scale 1.2
  translate 1.4 * x
}
