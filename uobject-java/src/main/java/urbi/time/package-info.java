/** What time it is: the only room of these that looks at the machine's clock. */
@NullMarked
package urbi.time;

import org.jspecify.annotations.NullMarked;
