/** What time it is: the only room of this module that looks at the machine's clock. */
@NullMarked
package org.urbi.ros.time;

import org.jspecify.annotations.NullMarked;
