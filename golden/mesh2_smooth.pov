// mesh2: the same kind of net with normals, colours blended between corners.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 3.2, -5> look_at <0, -0.2, 0> angle 42 }
light_source { <-5, 4, -4> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare N = 6;
#declare Height = function(x, z) { 0.35 * sin(x * 2.3) * cos(z * 1.9) }
mesh2 {
  vertex_vectors {
    (N + 1) * (N + 1)
    #for (J, 0, N) #for (I, 0, N)
      #local X = I / N * 4 - 2; #local Z = J / N * 4 - 2;
      , <X, Height(X, Z), Z>
    #end #end
  }
  normal_vectors {
    (N + 1) * (N + 1)
    #for (J, 0, N) #for (I, 0, N)
      #local X = I / N * 4 - 2; #local Z = J / N * 4 - 2;
      , <-0.35 * 2.3 * cos(X * 2.3) * cos(Z * 1.9), 1, 0.35 * 1.9 * sin(X * 2.3) * sin(Z * 1.9)>
    #end #end
  }
  texture_list {
    3,
    texture { pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 } }
    texture { pigment { rgb <0.9, 0.8, 0.3> } finish { phong 0.5 } }
    texture { pigment { rgb <0.2, 0.5, 0.8> } finish { phong 0.5 } }
  }
  face_indices {
    2 * N * N
    #for (J, 0, N - 1) #for (I, 0, N - 1)
      #declare A = J * (N + 1) + I;
      , <A, A + 1, A + N + 1>, mod(A, 3), mod(A + 1, 3), mod(A + N + 1, 3)
      , <A + 1, A + N + 2, A + N + 1>, mod(A + 1, 3), mod(A + N + 2, 3), mod(A + N + 1, 3)
    #end #end
  }
}
