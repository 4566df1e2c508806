"""Contact temperature, thermal growth of the flanks and the elastic modulus of hot steel."""
