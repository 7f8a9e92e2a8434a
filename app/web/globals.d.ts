/** Whether the page contains the code for pictures, set when the script is built. */
declare const PAGE_HAS_PICTURES: boolean;
