"""What a statement is: names and sorts, the setting, when its algebra exists, trees and how they print."""
