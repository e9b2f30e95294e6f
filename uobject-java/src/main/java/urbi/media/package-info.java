/**
 * Images and sounds as bytes: what their formats are, and how one becomes another (manual, "Binary
 * conversion"). It knows nothing of values and components; {@link urbi.UConversion} shows it to
 * them.
 */
@NullMarked
package urbi.media;

import org.jspecify.annotations.NullMarked;
