"""What a wrong answer says about its program: pictures, and whatever else shows the mistake."""
