"""What is known of one topic each; the rest of the package knows none of it."""
