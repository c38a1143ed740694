"""Test data: building cases, proving promises, pinning and caching them."""
