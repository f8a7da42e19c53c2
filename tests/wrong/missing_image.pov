// A picture that does not exist.
plane { z, 0 pigment { image_map { png "no_such_picture.png" } } }
