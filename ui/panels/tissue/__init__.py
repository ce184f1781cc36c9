"""The panel of the tissue workspace."""
