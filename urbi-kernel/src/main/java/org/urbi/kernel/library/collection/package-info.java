/** Lists, tuples and dictionaries (manual, "Container", "List", "Tuple", "Dictionary"). */
@NullMarked
package org.urbi.kernel.library.collection;

import org.jspecify.annotations.NullMarked;
