/**
 * What a component of an Urbi program is written with: values, UObjects and their variables, and
 * clients of a server.
 *
 * <p>Text is Unicode here and bytes in the kernel: a {@link String} travels as its UTF-8 bytes, and
 * bytes that come back and are no UTF-8 are read as ISO 8859-1, one character for each. Raw bytes
 * belong in a {@link urbi.UBinary}.
 */
@NullMarked
package urbi;

import org.jspecify.annotations.NullMarked;
