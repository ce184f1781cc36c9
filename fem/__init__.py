"""C1 finite elements on triangle meshes: arrays in, arrays out, no word of faces."""
