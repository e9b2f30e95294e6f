/** Lists, tuples and dictionaries (manual, "Container", "List", "Tuple", "Dictionary"). */
package org.urbi.kernel.library.collection;
