/**
 * Strings, characters, bytes, patterns and formats (manual, "String", "Binary", "Regexp",
 * "Formatter").
 */
package org.urbi.kernel.library.text;
