package org.urbi.ros.message;

import urbi.UValue;

/**
 * A constant of a message: it is not sent.
 *
 * @param text its value as it is written in the file
 */
public record Constant(String name, FieldType type, UValue value, String text) {}
