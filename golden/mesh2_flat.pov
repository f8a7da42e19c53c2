// mesh2: a hilly net without normals, each face flat, textures by face.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 3.2, -5> look_at <0, -0.2, 0> angle 42 }
light_source { <-5, 4, -4> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare N = 8;
#declare Height = function(x, z) { 0.35 * sin(x * 2.3) * cos(z * 1.9) }
mesh2 {
  vertex_vectors {
    (N + 1) * (N + 1)
    #for (J, 0, N) #for (I, 0, N)
      , <I / N * 4 - 2, Height(I / N * 4 - 2, J / N * 4 - 2), J / N * 4 - 2>
    #end #end
  }
  texture_list {
    2,
    texture { pigment { rgb <0.8, 0.6, 0.3> } }
    texture { pigment { rgb <0.3, 0.6, 0.4> } }
  }
  face_indices {
    2 * N * N
    #for (J, 0, N - 1) #for (I, 0, N - 1)
      #declare A = J * (N + 1) + I;
      , <A, A + 1, A + N + 1>, mod(I + J, 2)
      , <A + 1, A + N + 2, A + N + 1>, mod(I + J, 2)
    #end #end
  }
}
