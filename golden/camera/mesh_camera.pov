// mesh_camera: each pixel looks along the normal of a face of a bent mesh.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
  mesh_camera {
    1 0
    mesh {
      #for (J, 0, 23) #for (I, 0, 31)
        #declare P = <(I - 15.5) * 0.1, (11.5 - J) * 0.1, -4 + 0.02 * pow(I - 15.5, 2) * 0.1>;
        triangle { P, P + <0, 0.05, 0>, P + <0.05, 0, -0.001 * (I - 15.5)> }
      #end #end
    }
  }
  location <0, 0, 0.01>
}
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
sphere { <-0.5, 0, 0>, 0.8 pigment { rgb <0.8, 0.3, 0.2> } }
box { <0.4, -0.9, -0.3>, <1.2, 0.7, 0.5> pigment { checker rgb 1 rgb <0.3, 0.4, 0.9> scale 0.3 translate 0.03 } }
