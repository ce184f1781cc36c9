"""The panel of the Skull workspace."""
