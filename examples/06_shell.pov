// cargo run --release -- render examples/06_shell.pov
//
// A sea shell as a smooth mesh2: a circle that grows while it winds, computed in the scene itself.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
  location <-1.5, 4.2, -9>
  look_at <0, 1.5, 0>
  right x * image_width / image_height
  angle 36
}

light_source { <-7, 9, -6> rgb <1, 0.96, 0.9> }
light_source { <7, 4, -7> rgb <0.2, 0.25, 0.35> }
background { rgb <0.75, 0.8, 0.85> }

plane {
  y, -0.05
  pigment { bozo color_map { [0 rgb <0.85, 0.75, 0.58>] [1 rgb <0.75, 0.63, 0.46>] } scale 0.05 }
  normal { ripples 0.25 scale <1.5, 1, 0.5> rotate 20 * y turbulence 0.3 }
}

#declare Turns = 6;
#declare Along = 400;
#declare Around = 32;

// Point of the shell: `A` radians along the coil, `B` radians around the tube.
#macro Point(A, B)
  #local Size = exp(0.12 * (A - 2 * pi * Turns));
  #local Tube = Size * (1 + 0.06 * pow(abs(sin(8 * A)), 2));
  #local Ring = Size * 1.15 + Tube * cos(B);
  <Ring * cos(A), 2.35 * (1 - Size) + 1.05 * Tube * sin(B), Ring * sin(A)>
#end

mesh2 {
  vertex_vectors {
    (Along + 1) * (Around + 1)
    #for (I, 0, Along) #for (J, 0, Around)
      , Point(2 * pi * Turns * I / Along, 2 * pi * J / Around)
    #end #end
  }
  // Normals from the two tangents, by differences.
  normal_vectors {
    (Along + 1) * (Around + 1)
    #for (I, 0, Along) #for (J, 0, Around)
      #local A = 2 * pi * Turns * I / Along;
      #local B = 2 * pi * J / Around;
      , vnormalize(vcross(Point(A, B + 0.001) - Point(A, B - 0.001), Point(A + 0.001, B) - Point(A - 0.001, B)))
    #end #end
  }
  uv_vectors {
    (Along + 1) * (Around + 1)
    #for (I, 0, Along) #for (J, 0, Around) , <I / Along, J / Around> #end #end
  }
  face_indices {
    2 * Along * Around
    #for (I, 0, Along - 1) #for (J, 0, Around - 1)
      #local K = I * (Around + 1) + J;
      , <K, K + 1, K + Around + 1>, <K + 1, K + Around + 2, K + Around + 1>
    #end #end
  }
  uv_mapping
  texture {
    pigment {
      gradient x
      color_map { [0 rgb <0.98, 0.9, 0.8>] [0.5 rgb <0.85, 0.5, 0.35>] [0.6 rgb <0.6, 0.28, 0.2>] [1 rgb <0.98, 0.9, 0.8>] }
      turbulence 0.01
      scale <0.02, 1, 1>
    }
    finish { specular 0.4 roughness 0.03 reflection { 0, 0.15 } }
  }
  rotate 160 * y
  rotate -12 * x
  translate 1.12 * y
}
