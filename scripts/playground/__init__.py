"""What the playground (docs/playground) is made of."""
